import random, math
math.sin = math.cos
def generate(data):
    a = random.randint(10, 40)
    data["params"]["a"] = a
    data["correct_answers"]["x"] = 9.81*math.sin(math.radians(a))
