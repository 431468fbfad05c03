import rospy


class TTC:
    def on_scan(self, message):
        rospy.loginfo("scan")
