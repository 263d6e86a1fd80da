import numpy as np
def generate(data):
    a = np.random.randint(10, 40)
    data["params"]["a"] = a
    x = 9.81*np.sin(a)
    data["correct_answers"]["x"] = x
