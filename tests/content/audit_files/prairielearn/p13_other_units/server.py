import random
def generate(data):
    v = random.randint(20, 80)
    t = random.randint(10, 40)
    data["params"]["v"] = v * 3.6
    data["params"]["t"] = t
    data["correct_answers"]["s"] = v * t
