// create_publisher<std_msgs::msg::String>("in_a_comment", 10)
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    pub_ = create_publisher<std_msgs::msg::String>("chatter", 7);
    raw_ = this->create_publisher<std_msgs::msg::Bool>("latched", rclcpp::QoS(1).transient_local());
    sub_ = this->create_subscription<std_msgs::msg::Float32>(
      "~/input", rclcpp::SensorDataQoS(), [this](const std_msgs::msg::Float32 & message) { (void)message; });
    any_ = create_publisher<MessageT>("any", 10);
    named_ = create_publisher<std_msgs::msg::Bool>(name_, 10);
    other_ = create_publisher<std_msgs::msg::Bool>("qos", qos_);
  }
};
