import random
def generate(data):
    v = random.randint(2, 8)
    t = random.randint(10, 40)
    while t == v:
        t = random.randint(10, 40)
    data["params"]["v"], data["params"]["t"] = v, t
    data["correct_answers"]["s"] = v * t
