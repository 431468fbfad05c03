/** The output of commands: their streams, the terminal and its lines of progress. */
package dev.eventchain.cli.console;
