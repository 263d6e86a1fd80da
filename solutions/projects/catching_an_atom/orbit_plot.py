import matplotlib.pyplot as plt
import numpy as np

period = 2 * np.pi * np.sqrt({m} / {k})
places = [({b}, 0.0)]
r, v = np.array([{b}, 0.0]), np.array([0.0, {v0}])
for step in range(5000):
    length = np.hypot(*r)
    F = -{k} * (length - {b}) * r / length if length < {b} + {d} else np.zeros(2)
    v = v + F / {m} * period / 1000
    r = r + v * period / 1000
    places.append(tuple(r))
places = np.array(places)
plt.plot(places[:, 0], places[:, 1])
plt.gca().set_aspect("equal")
plt.xlabel("x [m]")
plt.ylabel("y [m]")
plt.show()
