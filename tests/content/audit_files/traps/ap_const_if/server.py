import random, math
g = 9.81
if True:
    g = 5
def generate(data):
    h = random.randint(5, 50)
    data["params"]["h"] = h
    data["correct_answers"]["t"] = math.sqrt(2*h/g)
