/** Event-chain models: reading and writing them as XMI, and the data flow inside them. */
package dev.eventchain.metamodel;
