package dev.eventchain.cli;

import dev.eventchain.pipeline.Today;
import java.io.PrintWriter;

/**
 * Where a command writes, and what day it is there.
 *
 * @param out results
 * @param err progress and findings about the command itself
 * @param terminal what {@code err} is written to
 */
record Console(PrintWriter out, PrintWriter err, Terminal terminal, Today today) {}
