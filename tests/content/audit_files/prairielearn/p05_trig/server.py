import random, math
G = 9.81
def generate(data):
    a = random.randint(10, 40)
    data["params"]["a"] = a
    data["correct_answers"]["x"] = G * math.sin(math.radians(a))
