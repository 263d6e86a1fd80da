import random
def generate(data):
    k = random.randint(2, 8)
    v = 3*k
    t = random.randint(10, 40)
    data["params"]["v"] = v
    data["params"]["t"] = t
    data["correct_answers"]["s"] = v * t
