def generate(data):
    data["correct_answers"]["s"] = 100
