import matplotlib.pyplot as plt
import numpy as np

T = np.pi * np.sqrt({m} / 2 / {k})
t = np.linspace(0, 1.2 * T, 400)
half = {v0} / 2
plt.plot(t, np.where(t < T, half * (1 + np.cos(np.pi * t / T)), 0), label="A")
plt.plot(t, np.where(t < T, half * (1 - np.cos(np.pi * t / T)), {v0}), label="B")
plt.xlabel("t [s]")
plt.ylabel("v [m/s]")
plt.legend()
plt.show()
