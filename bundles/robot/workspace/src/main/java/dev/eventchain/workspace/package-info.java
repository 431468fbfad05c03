/**
 * Existing software of ROS 2 as a software base: workspaces, read without running anything of them.
 */
package dev.eventchain.workspace;
