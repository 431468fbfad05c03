from base import Base


class TTC(Base):
    pass
