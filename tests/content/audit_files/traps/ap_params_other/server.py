import random
def generate(data):
    v = random.randint(2, 8)
    t = random.randint(10, 40)
    data["params"]["v"] = t
    data["params"]["t"] = v
    data["correct_answers"]["s"] = v * t
