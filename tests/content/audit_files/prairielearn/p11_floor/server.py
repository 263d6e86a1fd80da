import random
def generate(data):
    m = random.randint(1, 5)
    v = random.randint(2, 10)
    data["params"]["m"] = m
    data["params"]["v"] = v
    data["correct_answers"]["E"] = m * v**2 // 2
