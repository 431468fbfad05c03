/** The command line over the pipeline: the only place that prints or decides how a process ends. */
package dev.eventchain.cli;
