package dev.eventchain.cli.console;

import dev.eventchain.pipeline.Today;
import java.io.PrintWriter;

/**
 * Output streams and date of a command.
 *
 * @param out results
 * @param err progress and findings about the command itself
 * @param terminal the terminal behind {@code err}
 */
public record Console(PrintWriter out, PrintWriter err, Terminal terminal, Today today) {}
