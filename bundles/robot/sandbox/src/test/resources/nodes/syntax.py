class Brake(:
    pass
