// The answer to any question of a server, with grpc-go and the stubs of `protoc
// --go_out --go-grpc_out` as package `geodesic`; and the reason that an error has for
// programs.

package answer

import (
	"bytes"
	"context"
	"encoding/binary"
	"io"
	"time"

	"google.golang.org/genproto/googleapis/rpc/errdetails"
	"google.golang.org/grpc"
	"google.golang.org/grpc/status"

	"example.org/geodesic"
)

type answers interface {
	Recv() (*geodesic.Answer, error)
}

// The bytes of an answer's arrays by name.
func read(stream answers) (map[string][]byte, error) {
	var infos []*geodesic.ArrayInfo
	arrays := map[string][]byte{}
	complete := false
	for {
		answer, err := stream.Recv()
		if err == io.EOF && complete {
			return arrays, nil
		} else if err != nil {
			return nil, err
		}
		if header := answer.GetHeader(); header != nil {
			infos = header.GetArrays()
		}
		for _, block := range answer.GetBlocks() {
			name := infos[block.GetArray()].GetName()
			arrays[name] = append(arrays[name], block.GetValues()...)
		}
		complete = answer.GetTrailer() != nil
	}
}

func numbers[T any](array []byte) []T {
	values := make([]T, len(array)/binary.Size(*new(T)))
	binary.Read(bytes.NewReader(array), binary.LittleEndian, values)
	return values
}

func distancesFrom(conn *grpc.ClientConn, mesh string, vertex uint64) ([]float64, error) {
	ctx, cancel := context.WithTimeout(context.Background(), time.Minute)
	defer cancel() // also when the loop is left early
	stream, err := geodesic.NewQuestionServiceClient(conn).ComputeField(ctx,
		&geodesic.ComputeFieldRequest{MeshDigest: mesh, Sources: []*geodesic.Source{
			{Place: &geodesic.Source_Vertex{Vertex: vertex}}}})
	if err != nil {
		return nil, err
	}
	arrays, err := read(stream)
	return numbers[float64](arrays["distance"]), err
}

func reasonOf(err error) string {
	for _, detail := range status.Convert(err).Details() {
		if info, ok := detail.(*errdetails.ErrorInfo); ok {
			return info.Reason
		}
	}
	return ""
}
