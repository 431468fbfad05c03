from setuptools import setup

scripts = ["filter = guard.nodes:main", "limiter = guard.nodes:limiter", "odd = guard.odd:main"]
setup(name="guard", packages=["guard"], entry_points={"console_scripts": scripts})
