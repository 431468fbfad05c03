/**
 * The doors that the command line and the Maven plug-in use: runs of a project, generation without
 * one, and how a command ended, with its exit code. What the stages do is in the packages below;
 * this one knows neither diagrams nor evaluations.
 */
package dev.eventchain.pipeline;
