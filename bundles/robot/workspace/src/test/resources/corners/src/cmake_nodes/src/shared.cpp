#include <rclcpp/rclcpp.hpp>

int main(int argc, char **argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("shared");
  auto publisher = node->create_publisher<std_msgs::msg::Bool>("shared", 1);
  rclcpp::spin(node);
}
