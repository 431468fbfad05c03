from setuptools import setup

setup(
    name="corner_nodes",
    entry_points={
        "console_scripts": [
            "many = corner_nodes.many:main",
            "kept = corner_nodes.kept:main",
            "gone = corner_nodes.gone:main",
            "plain = corner_nodes.many:helper",
            "broken = corner_nodes.broken:main",
        ]
    },
)
