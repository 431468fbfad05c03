class One : public rclcpp::Node { One() : Node("one") { create_publisher<std_msgs::msg::String>("a", 7); } };
class Two : public rclcpp::Node { Two() : Node("two") { create_publisher<std_msgs::msg::String>("b", 7); } };
