/** ROS 2 message definitions, field paths, and the encoding of messages on the wire. */
package dev.eventchain.messages;
