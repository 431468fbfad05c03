project = "Radar"
