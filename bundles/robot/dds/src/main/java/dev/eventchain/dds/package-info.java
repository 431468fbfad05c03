/** Messages over Eclipse Cyclone DDS, as ROS 2 exchanges them. Independent of event chains. */
package dev.eventchain.dds;
