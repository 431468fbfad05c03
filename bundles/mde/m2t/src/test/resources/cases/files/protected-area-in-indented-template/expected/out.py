class Oak:
    def trunk(self):
        # Start of user code trunk
        if self.tall:
            return 7
        # End of user code
    def root(self):
        # Start of user code root
        pass
        # End of user code
    def bird(self):
        # Start of user code bird
        pass
        # End of user code
