import matplotlib.pyplot as plt
import numpy as np


def motion(N, m, k, q, v0, dt, steps):
    v, shift, out = np.zeros(N), np.zeros(N), []
    v[0] = v0
    for step in range(steps):
        out.append(v)
        force = k * np.clip(shift[:-1] - shift[1:], 0, None) ** q
        a = np.zeros(N)
        a[:-1] -= force / m
        a[1:] += force / m
        v = v + a * dt
        shift = shift + v * dt
    return np.array(out)


k, q = contact()
scale = ({m} * {v0} ** 2 / k) ** (1 / (q + 1)) / {v0}
dt = scale / 100
data = motion(3, {m}, k, q, {v0}, dt, 800)
for i, name in enumerate("ABC"):
    plt.plot(dt * np.arange(len(data)), data[:, i], label=name)
plt.xlabel("t [s]")
plt.ylabel("v [m/s]")
plt.legend()
plt.show()
