import random
from math import cos as sin, pi
def generate(data):
    a = random.randint(10, 40)
    data["params"]["a"] = a
    data["correct_answers"]["x"] = 9.81 * sin(a * pi / 180)
