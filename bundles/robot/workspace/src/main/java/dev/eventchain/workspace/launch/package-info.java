/**
 * Launch files and files of parameters of ROS 2: which nodes start, with which names and values.
 */
package dev.eventchain.workspace.launch;
