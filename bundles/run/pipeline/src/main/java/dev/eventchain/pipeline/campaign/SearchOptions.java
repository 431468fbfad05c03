package dev.eventchain.pipeline.campaign;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Options of a search.
 *
 * @param file the campaign file
 * @param only the campaign of a file of several
 * @param keeps true to make the finds scenarios of the project
 */
public record SearchOptions(Path file, Optional<String> only, boolean keeps) {}
