package dev.eventchain.workspace;

import dev.eventchain.messages.QosSettings;
import java.util.List;
import java.util.Optional;

/**
 * A publisher or a subscription of a node.
 *
 * @param topic the full name, after remapping
 * @param type the full name of the message type
 * @param qos empty if the source does not say
 * @param fields the paths of the fields that are used; empty if they are not known
 * @param file the file that makes it, relative to the workspace
 */
public record FoundEndpoint(
    boolean isPublisher,
    String topic,
    String type,
    Optional<QosSettings> qos,
    Optional<List<String>> fields,
    String file,
    int line) {}
