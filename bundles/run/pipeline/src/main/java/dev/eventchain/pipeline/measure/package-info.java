/** Recorded traces of ROS 2, compared with a project's chain; babeltrace2 reads them. */
package dev.eventchain.pipeline.measure;
