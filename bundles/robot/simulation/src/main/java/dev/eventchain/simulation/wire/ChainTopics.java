package dev.eventchain.simulation.wire;

import dev.eventchain.messages.MessageCatalog;
import java.util.Set;

/**
 * Topics of a chain that nodes running elsewhere must have.
 *
 * @param written topics that the chain writes
 * @param taken those of them that the vehicle consumes
 * @param nodes names of the chain's nodes in ROS 2, without namespace
 * @param catalog the definitions of the world's messages
 */
public record ChainTopics(
    Set<String> written, Set<String> taken, Set<String> nodes, MessageCatalog catalog) {}
