import random
def generate(data):
    v = random.randint(2, 8)
    t = random.randint(10, 40)
    data["params"]["v"] = v
    data["params"]["t"] = t
    data["correct_answers"]["s"] = v * t
    data["correct_answers"]["s"] = v + t
