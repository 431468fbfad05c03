package dev.eventchain.workspace;

import java.util.List;
import java.util.SortedMap;

/**
 * Software that exists.
 *
 * @param nodes in the order in which they are started
 * @param sources the Python modules of its packages, by their files below the folder from which
 *     they are imported
 * @param questions what is not known of it
 */
public record FoundSoftware(
    List<FoundNode> nodes, SortedMap<String, String> sources, List<OpenQuestion> questions) {}
