/** The command line for the pipeline: the only code that prints or determines the exit code. */
package dev.eventchain.cli;
