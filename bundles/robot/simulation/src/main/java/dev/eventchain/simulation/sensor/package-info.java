/**
 * What sensors of the ego vehicle see of the world: lidar scans and lists of objects. Knows no
 * topic and no bench.
 */
package dev.eventchain.simulation.sensor;
