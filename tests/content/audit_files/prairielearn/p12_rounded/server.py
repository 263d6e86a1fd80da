import random
import math
def generate(data):
    h = random.randint(5, 50)
    data["params"].update({"h": h})
    data["correct_answers"]["t"] = round(math.sqrt(2 * h / 9.81), 3)
