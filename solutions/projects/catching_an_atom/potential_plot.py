import matplotlib.pyplot as plt
import numpy as np

k, b, d = {k}, {b}, {d}
U0 = k * d**2 / 2
x = np.linspace(b - d, b + 2 * d, 400)
plt.plot(x, np.where(x < b + d, k * (x - b) ** 2 / 2, U0), label="U")
plt.plot([b - d, b - d], [U0, 6 * U0], "k", label="wall")
plt.axhline({eps} * U0, color="C1", label="E < U0")
plt.axhline({epsx} * U0, color="C2", label="E > U0")
plt.xlabel("x [m]")
plt.ylabel("U [J]")
plt.legend()
plt.show()
