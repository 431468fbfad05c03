package dev.eventchain.openscenario.document;

/**
 * The header of a file.
 *
 * @param version {@code 1.0} to {@code 1.3}
 */
public record ScenarioHeader(String version, String author, String description, String date) {}
