package dev.eventchain.workspace;

import java.util.List;

/**
 * Software that exists.
 *
 * @param nodes in the order in which they are started
 * @param questions what is not known of it
 */
public record FoundSoftware(List<FoundNode> nodes, List<OpenQuestion> questions) {}
