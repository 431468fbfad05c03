/** Sensors of the ego vehicle: lidar scans and lists of objects. Knows no topic and no bench. */
package dev.eventchain.simulation.sensor;
