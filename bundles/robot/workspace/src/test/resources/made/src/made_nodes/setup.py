from setuptools import setup

setup(
    name="made_nodes",
    entry_points={
        "console_scripts": [
            "own = made_nodes.relays:main",
            "sides = made_nodes.sides:main",
            "plain = made_nodes.plain:main",
            "front = made_nodes.shared:front",
            "rear = made_nodes.shared:rear",
            "asked = made_nodes.asked:main",
        ]
    },
)
