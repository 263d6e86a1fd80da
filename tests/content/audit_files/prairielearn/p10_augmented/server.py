import random
def generate(data):
    m = random.randint(1, 5)
    v = random.randrange(2, 10, 2)
    E = m * v**2
    E /= 2
    data["params"]["m"] = m
    data["params"]["v"] = v
    data["correct_answers"]["E"] = E
