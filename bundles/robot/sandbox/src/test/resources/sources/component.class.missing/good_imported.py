from helper import TTC
