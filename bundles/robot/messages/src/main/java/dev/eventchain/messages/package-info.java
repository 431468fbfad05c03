/** ROS 2 message definitions, the paths of their fields, and their form on the wire. */
package dev.eventchain.messages;
