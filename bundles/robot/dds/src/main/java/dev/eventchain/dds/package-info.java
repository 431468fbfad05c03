/** Messages over Eclipse Cyclone DDS, as ROS 2 exchanges them. Knows no event chain. */
package dev.eventchain.dds;
