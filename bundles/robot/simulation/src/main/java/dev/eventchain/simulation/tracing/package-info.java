/**
 * Recorded traces of ROS 2 (ros2_tracing, LTTng) as measurements of a chain: events as babeltrace2
 * writes them, the activity of nodes, and the latencies between them. Starts no program.
 */
package dev.eventchain.simulation.tracing;
