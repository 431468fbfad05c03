/**
 * The API of the command line and the Maven plug-in: runs of a project, generation without one, and
 * outcomes of commands with their exit codes. The work of the stages is in the packages below; this
 * one depends neither on diagrams nor on evaluations.
 */
package dev.eventchain.pipeline;
