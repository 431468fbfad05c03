/** What OCL cannot say about an event chain: message contracts, and what the data flow implies. */
package dev.eventchain.contracts;
