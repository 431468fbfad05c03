package dev.eventchain.simulation.wire;

import dev.eventchain.messages.MessageCatalog;
import java.util.Set;

/**
 * The topics of a chain that nodes of others have to have.
 *
 * @param written those that the chain writes
 * @param taken those of them that the vehicle takes
 * @param catalog has the definitions of the world's messages
 */
public record ChainTopics(Set<String> written, Set<String> taken, MessageCatalog catalog) {}
