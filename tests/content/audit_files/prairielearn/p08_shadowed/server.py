import random
def sqrt(x):
    return x ** 2
def generate(data):
    h = random.randint(5, 50)
    data["params"]["h"] = h
    data["correct_answers"]["t"] = sqrt(2 * h / 9.81)
