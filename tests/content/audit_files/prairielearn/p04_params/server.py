import random
def generate(data):
    data['params']['v'] = random.uniform(2, 8)
    data['params']['t'] = random.choice([10, 20, 40])
    data['correct_answers']['s'] = data['params']['v'] * data['params']['t']
