import random
def energy(m, v):
    return m * v * v / 2
def generate(data):
    m = random.randint(1, 5)
    v = random.randint(2, 10)
    data["params"] = {"m": m, "v": v}
    data["correct_answers"] = {"E": energy(m, v)}
